// SPDX-License-Identifier: MIT
// Made by tests/bench/fit_priors.cpp.
#include "core/codec/coefficient_priors.h"

#include <array>

namespace mocapress {
namespace {

// clang-format off
constexpr std::string_view kContexts =
    ",<=@DHLTDEFGILPYJKKLOQSWHKJKLPRWKNNNOQTXLOMOQQUYMSQRSUV[NVMSSWZ_/>?BEHLTJHJKMOQWKKLMNPRUKM"
    "LMOQSXONOPQRTYQQRRRTVZUTVTTVX] V X^Z[_1>@CFIMUKJJKMNQWLLMNNPRWMNNNPQSWOPQQRSTXTRTSTUVZWTWW"
    "VWY] __U]]]b4=@CFINWHIJJMNQWLLKMMOSWMMMMPQSXOPPQQSUYTTRTUTW[UUWWVWY^UZWXX]^d:ADFILPZJHIJLN"
    "RWMLMNOQSXMMMONQTXQQQQSSUZTTTTUUX[VVYVWWZ_[`[Z^]^eEEHJLQVbIJJLNQSYNLMNPRUZOOOOPSU[TQQRSTW]"
    "XTUUTVX^]ZXY[ZZ`gcjec`agMEJLOSXjJNMMOSU]OLLMORW[QPOPQSW[TPSRSUX[[SUTVXY^_[YWYZ[al fb^caiVH"
    "ORTX^jKJMOQSTYPLLNRTW_UOORQTW^XUPUUVZa_aWVVWZ`cX]Y]]]aqehZ`aci'79<?BHTDDEEGIMVFGHIKMOWGHIJ"
    "KMQVIHLMMORYOMMOPRT[[VXSPUX^r    W_h-:;>ACFNDCCDGGJQJGIJKMMQEGGGHKOUGKKKMLQUJHMKMNQU  QQOP"
    "RT       S.=>@DFJPGFHGIKPPIIIKKMOUFHHIJLOVKJJKMNQWISKLOOSV  VSPPSV      UV2>@BEHLRJHIHKLOV"
    "LIKLMNOTIJJKLMOTKKKMLOQVLMLMONQXISORQRT[    QTVX3?ACGIMSKIJJLMPULLLMNPQUKMLLMOQUNNNNOPRWOO"
    "NPPQSWPVRQQSTY    RXTX5@BEHKOTJJKKMOQVLLMNOPRVLMMNOQSWOPPPRRSWQRQQRSUXSSSRSTVZ  VRZUZ`7ACF"
    "ILQWJJKLNPRWMMMNOQSWMONOPRTXQPQRSTUXUSTSTUVYVSVVUWX]QRWXYZ[a@CEGJNS]JJKLNPSYNMMNOQTYNNNOPR"
    "UYRRRRSTVZVTUVVVX[ZWWXXXZ^ef_W]`_dOFJLNRWeKMLNORUZPNNOQRV[RPPQQTV]USSTTUX][UVUVWY_aX[YZZ[a"
    "mic```af      __              Z[`   TWd]a    OYf^   XV_ad `Tg^`dy `Vcbbl4;GK08< 47>C49?G8;"
    "AG;>EI=ALXAELSFHPYGOWd+4DG-18?138C55;B79>E;;@H=>CL?@EO@BHQ=GLVBDHGAAB=@AE@AAEDBBDECDFJDEHO"
    "FGJQGHMTGLQY?JJKBAC@CCDFEEEGFEGHGGHKHIJPIJLPJKNSJNR[ MMVD   GIJ HHILHJKMJKMMKLMRMMORNNPTNP"
    "SZ    H   IJ  KG  KKO MNPPNOQVPQQSRRSURSUZ    J       J   L   OMQ PSV`RSTVTUUXUVW[        "
    "        J   LM  OPbjTUVZVWXYXYZ^                    H   R doQ[_ XWXZY]_a                  "
    "        kxW   VVbZ]adi##/2378<?CGJMPRTWXZ]][baclk     %$0347:=@CGJMPRUVXYZ]Yaeebc     )&/2"
    "569<?BFIMPRUWYZ]^[bdklob    ,)0/468;=@DHKORUWY[^``dhim|s    5-458;;<?BEGJNQTWY[^`adfilnsg "
    "  H68<:??A@CEGJNQTWZ]_abeglloxr   V=8;HD@BBDFGKNRUXZ]`bcgjlrrsw   n     JOOGIJMPTWY]_`cefl"
    "kptvt   KJHIKNRYJGGILOSZIFHJLNSYIGHIKNS[JGHJLOT^RHJLNQVaUJMMORVcXLOPQTYeCGGGHJNUFDEEGINVDD"
    "DEGINUECEFGJNWIBGFHKOYVIIIJLQ]WIKKLNR_YKNNOQUaEFFGFFJR?CBEDFJSGEDBCEIRGFGEDFJSKDIEEGKVWFKI"
    "JJMXV9MKKLOZXGNONOQ^?@=BEDFO =9CBDEO@=E<@CEO @EFEDFPQ JHHEGSW?IGHIJUU KKKJLWWTNONNOZ   >F@"
    "FN   =:ADN    =BCN   FHEEOP JPLHGQV OQHHITU NNMJKVW PQNNNX      BL     @AN     @AN     ICN"
    "J  @=MBPU QOFLHRU JSKMKTU KMRLOV       M       L      JN      <M     HIOS  T NKQR  LOKKST "
    "FNOQMT       M       M       M       M      OMP  M PINO   M@LPR  MMMORJKLNQTYcJKLNPSV_KLMO"
    "QTV_KLMOQTW_LMNPRTX_NNOQSUX_PPPRTWZ`XQSTVY^fIIIJLOU_HIHIKNR[IIIKLOSZIIIJLOSZJIJKMOSZLKKLMP"
    "TZOLMNPRU[YOPQSUXbMFGHJLQZIFEFHJNXKFGGIJOXJGGHHKOWKGGHIKOWLGGIJKOVPJJKKMQWXLMNOQT^SEHGIJMW"
    "LCEGGGKUKEBCEHKUKEDFFGJSLCHFFHKSOEGFFHKSOFGHHILSWKKLLMPYTIJIIKLUN FAGHJSKO=DJHKSM<ACDGIRMD"
    "GEEEJPNDDGFFIPPFFHHGIQVHJJKKMVUFEGHIKSN   GHIRO   DFJQL  ?IFJRN IHFDHQM LAEGGOO=JHEFGOUEKI"
    "IJKTT JFJIIRS     PPQ     KOK    ?KQL    OBPK   JCHON GGLFENS GKJJJRR   GBHOQ     KOM     "
    "=OG     FNL     HNI     FOK   GIHNQ JIKHJPLHGOFGGLEGGLGHGLJJINJKJPLLKROLLUXNOZh XhQEEPCFCH"
    "FBEKBEDJDCDJGGGMHIIOPIKRYMMWh ZcYDGR@F=H:<CICDEJCD@JEDBMFFFMSJJPXKMU` S_Z@DS   K   J @FIF="
    "=JD@>NEBELRIINXLMT^ P[X  T   C   L   K   J   OOJCMRFFOWNLS^ OYX  S       C   L   K   N   M"
    "Q =OVNLRZ  VV  S       J   J   I   N   MM  NTLQQW  TR  P           F   L   M   MK  LRJLOS "
    " QGIIHHISNQ[EHHHGHHILNEGIGHHJKMQKGJJJJKLNQOTLMLLMMOQ bQNOOPPQS   TQQUSTV    `S_UVY      nV"
    "X]      rRWcADEEDFUKOY9CDDDDFFILCEEFFFHGJOCEEEFFHHJOEHAFHHIIKO RFOMJLKLP    LORNOR    QQ]R"
    "RU      fUUX      oUV`?:AFCEWGLW EF;@CEEHK KJEFEHFHN JFDGCIFHN   EFDIFHM M GHFLGHM    LLRJ"
    "JN     NZNNQ      bQRU      jTT]   @ GWFFV    @9GHIH  M=@BJEEM   ?HFKFHL   @DHLEFL    KCNE"
    "EL    ?KRFFL     MZKIM      ^KMQ      fFPX      VHFU      ?@?I      Q<CK    >=M@IL     IOH"
    "FK    L>OGEL     JRFEK      ULFL      ZTKN      b LV      U KT                N  J      P "
    ";J      KE8K      PKIJ      OGCK      QGCK      VLKL      ^ QT      T  S                K "
    " G      Q  J      P  K      M<;J      MMJJ      OLHJ      P=HK      Z KR      Q  Q        "
    "        M         M  I      M  E      N  K      N  J      M  I      M @I      S JPQGDGFFEF"
    "FGHJLNPSUXZ]_`cfilov{   W@?>BDBBBBCEFHKMPSUWZ]_behlps   ]   <G=ADABCDEFHKNPSUXZ^adhmk   ] "
    "     @GEHCIIFFGIKNQTVY[`dhl   X         FMNOMJHHIJLORUX[`ei   W          HPSNMLJIHILNQSWZa"
    "d   U           NUPNMMKJIMKMOSV[_   R           IQLPLMNMKPKNLOQSS                         "
    "          HGDEFEFFFGGHIJKMNNNOONOOOOOK    R   ECDEDDFEGHIJKMMNNNOOOOOPQ   N      @IBEGGGHH"
    "IJLMNNNOOPOPO   L         PJLHHHHIJKLMNNOOOON   M          TPLILHGIIIKLMNOONO   N         "
    "  PLKLKIIGIIJKMNNOR   N           MMIJIJJJIKJKKLLMM           KKLLMMMNJKKLLMMNKKKLLMMNJKKL"
    "LMMMKJKKLLMMMJKKLLLMKJKKKKLL                                                              "
    "                  K       HK      HIJK    IIJJL   JJJJKMP KKKLLMN LLLLMNNOMMMMNNNOKLJLNOOO"
    "NLLNLOOOL       FI      HIJI    HIHJJ   HHHIIKM IIIIJKM JKJKKKMNKLLLLMMNMLMLMMNOMMLLNNNOM "
    "      JH      IFJH    IKHKK   HFFIJKL IGHIIJL JHIIIJKNKKJKJKLNMMKLLLMNMIMMLNNOM       JL  "
    "    LJJM    HKGJM   GFJHHKL FIHFGJK JIJGIIJMHKIHIIJMHJLJJKKMMMLLLKMNM                 K   "
    "     KH   H O=GKM   JEJIJ  FJHFEJK?JFHIHIKG=FGIJILMLKMLKKMM                 K        PH   "
    "    ?JK     @CM     ?OJI   @AIFK@ ONIJIK  FDGJKLL                 H        DO        MP   "
    "   MI       IK    H=GK     =GK   >JJIL                                PLJLNOO KMKLNOO NFIK"
    "MOO O PMNOP H ILLNOJO PNMNO N  MKMONL JMLNOSK  LLMNOI  PMMNOJ  LLLMMO  LMMNLOPNOPLOROLMKON"
    "LJLKRTRSSRPRQOPNNOMOQOMNMNNMNNMQRPOQPOQPOPNOPMPQONNLOOMMNLPRPPQPPQPOPNOPMOQNLMKMNLMMKQTQRR"
    "PPRPNOONPMPQNLMKNNLLMKQSQQSQQRPPMQNOOPPOONLMMMNNLOQQOQQQQPOKSOMMPQOONONMNNNNPPPQOPRPQOMQON"
    "NPQQOPPKPOMOQPNNPMOROOOONOPPNNNMRPOPLNPQMONKQONPNMQPQSNOSRROMOPSMKKLPPPNMNPQ2LRW^dlrok1INP"
    "TW]but3DIMQUZ`j|4@EJPT[fo|9EEIOT[hm|>IKMPVWly|? MGKTTfl|E MOPSXiq|1FGFJKDSV BJQUVVZbox4IJL"
    "NQP]fy=GLMNPL`d KOTXY_cit|@JOQSX[hp|                    6GOIRQbemx                        "
    "                                    + EHR_gfb_2LSX`ekrnk                                  "
    "                          1G2AHNU[pq1IQUY`hmrp                                            "
    "      3 >@FMRWdx4JIMQT`qpr3DJPU_ivuv                                        :  GNOV_iz3 CC"
    "LQWcsy4?7JMXfngu-@GLSXhvuy                              A   KPXii{4  DFNVah|2  >OWemow3KGK"
    "SVdpqv'DELT_ctt{                    C    OUghr@   OSZhs|;  KPXammx8 EKOSYhqy9JJMR`hqr{:HQQ"
    "Y]lllv                    ?    LTZ]rD   GPZfnx?  ECQYbpz8 NDN[bpq|> JKV_jklv              "
    "                E    LXkkxF   NQYen|C  PRWcrr|= MLQ^kklw                    UUOI'         "
    "                  KF.                             X^[ZYXVUTSRPNKJJJ               UZYXWVUT"
    "SRQPONNSRNO             wwolhdc_^ZWUUSOKJ@              efbb^[YYXVUTRSPNKH              wV"
    "YQ-           TUOG*                                                                       "
    "                                                                                          "
    "                                                                          MF7             "
    "JF/                                                                                       "
    "                                                                                          "
    "                                                            X][ZXWVUTSRQNMLIGPPOPPJ       "
    "  UQNNRQO         ZXPMMOO         ^_XNOMNO        da[VNOLOH       fe__UPLIO       tlaa`VOJ"
    "HO      tttc_`VKIG      ssskka_VJKD     rrrrgac`UKHF    qqqqqqab`VJG?   pppppphcddWHJ?  oo"
    "ooooogdddTGD  kkkkkkkkk`c]XF? ddddddddddZcZS> UYYXWVUTSRQQOOPRINOPNTMH        RRPONOMO    "
    "    ZXTQPONK        _[VQPOOSMQ      dc]WQOPKOG      nf`[WQMQPQK     iif`^VPMNNQG    mfmf`]"
    "VOLONN    ttlgia^WNKPRTH  sssshh^ZVOKPQL  qqqqfi`_]TNJRQ  ooooogogc[VLHO  llllllladlZWMJO "
    "hhhhhhhhh_g_TH                  wwolhdc_^ZWUUSOJ                                          "
    "                                                                                          "
    "                                                                                          "
    "                  efbb^[YYXVUTRSPM                                                        "
    "                                                                                          "
    "                                                                                          "
    "    PTSQ*           RPMI4           [XNH0           xYID<           f^R-            R^RA< "
    "          [Z[><           UOP7            VQI`?           XM<             pK5             "
    "XQA?            oZ1                                                             HC5       "
    "      OG2             UL7             fS<             J5                                  "
    "                                                                                          "
    "                                                                                  PXXYZZ]Y"
    "WUURNK< SWUTSSQOLRJ     UWWTTRPSQMJ     XXWVUSPOONNO    YZXWVUSRNOROG   Y_YXWVTSQMPRO?  [`"
    "]XXVTRQOLPF   ]_^ZXXVSSSNLKJ  ]c`_YXWTSRSNIJ  ^fc^^XXVSRPOOF  `lb_]ZYWUTQONJ@ dneab[ZWWWRN"
    "LPF ummeaaYZUVVQMG  qqqff^e[[XVRLLH pppphh][YYWVTQQJUZZYXVUTSRQPNLNPHMNNTQOQ        QPOLJN"
    "          TSRNPNKH        YVTQPNOON       ^[VSQPMLQL      a^ZVRPONLR?     gb^[VRQMOMOO    "
    "iha[ZVRPNNKVJ   nik_[YTROOLK    umjd_]XVROPPMVJ ssksh^[YUOQKMJ  qqqiif^YZUORJL Onnnnnf_]ZU"
    "RRPNORllllllldZYUSNO@ hhhhhhhhh__ZZWQRqqqqd_]XVURQQMH                                     "
    "                                            bbbbbbbbbRQ     cccccccccZK     fffffffff^YH  "
    "  ggggggggg_WYPP@ iiiiiiiiiXRTdNQ kkckkbkkb_WQWTKPkkk_jjb_^^]XQUVHhhhh_ggg[Z^^TRTNiiiia`hh"
    "```__UJ@lllllldadd]^YWSJgfca^]ZXXWVSRTRMaaO             ``V_T           TV_O            cV"
    "XbJ           ^ff]VRTQ        _g^f^USUO       [g__gXSTOJ      iaaaXWTXQTM     iia``XXTWMO "
    "    ai`hhhXXWPOT    gg__g_g^^^MRO   iiiiii``XUTLO   hhh__ggg_VTPG   cccccYbbbbbXTM  hhhhhh"
    "hhhhhhhYPK                cSKE?           bbb-            Oq].            rbb-            "
    "vWLD<           {[QH0           UOOL4           PTSQ*           PQJ4            TQ=?      "
    "      qq.             aYC<            pXGS<           XWXC<           XO-                 "
    "                                                            J5                            "
    "  ?               JM9             HC5             PE4             WL7             fS<     "
    "                                                                                        PX"
    "XXZZ[XWUURNK< SXWURSQONOM     TXXUURPSPMK     WYXWWUQPPNPL    ZZXXWWTROOQNF   [`YXWWUURNPO"
    "O>  ]_]XXVTSRQMRF   __^ZXYVSSSOMLG  bc`_YXXSTRSNKI  eec^^XWWSSPOPF  hlb_]ZYWVTQONK@ nvebb["
    "ZWWWROLPF tllgacY[UVWQMG  qqqep^e[]WVRLMH oooogg`^XYVZTRQJ                NTVUUUTSTTROOLH "
    "PTTSRONPMOT     SUTTTRPOPMNO    VWWUSSQPQPLN    XZXVUSSPONQMM   Z]ZWVTRROPJSN  O]`]YVTSRQO"
    "MHO   ab_[YVTSQONL;   fd`^ZYVTSPOMKG  lfe`_YXUSRQOMI  jlea^]ZYTQPSLK@ muuca_ZWYUSPPHO sskh"
    "da^ZXVTROQMNphphhb^[XWXSPJQRqqqhee_^YWUXVSRSqqqqd_]XVURQQMH                               "
    "                                                  bbbbbbbbbRQ     cccccccccZK     ffffffff"
    "f^YH    ggggggggg_WYPP@ iiiiiiiiiXRTdNQ kkckkbkkb_WQWTKPkkk_jjb_^^]XQUVHhhhh_ggg[Z^^TRTNii"
    "iia`hh```__UJ@lllllldadd]^YWSJldcb]ZXXUSSSNQTNbXaaaWVT        YXT`VT          W]UVXbXW``Q "
    "    XYY[[ZVbbbUL    jjW]ZYVUWcQWH   dl^[XWWVWVZQRO  emm[]XWV[R]XRXO dlld]ZYVXYR[SUWJdlll_]"
    "XZSYUScZI lllll__ZZTSTSSaFbjajjjaY`UVScOVNiaiaiiiiX[ZSUYOQgggg_gggZWXWNT RbbbbbbbbbTVT    "
    "ccccccYXbbbXaRJ  PJLG                            GD                              NNMNMNNML"
    "MMLIEJ                 OMMMMMLMLLKLKLQFJ                  QSOLNRONMMNOKJ               ROO"
    "OONNLNNMJOLGH@              ";

constexpr std::array<std::int16_t, 200> kWeights = {
    -443, 742, 1071, 307, 307, 307, 307, 307,
    -103, 991, 150, 650, 163, 307, 307, 307,
    331, 406, -41, 514, -167, 307, 307, 307,
    311, 195, 135, 610, 6, 307, 307, 307,
    435, 170, 123, 426, -30, 307, 307, 307,
    517, 67, 278, 225, -148, 307, 307, 307,
    283, 174, -15, 507, -111, 307, 307, 307,
    379, 137, -113, 708, -231, 307, 307, 307,
    -64, 176, 263, 481, -190, 307, 307, 307,
    388, 323, 198, 159, 522, -320, 307, 307,
    322, 395, 45, 25, 603, -322, 307, 307,
    357, 289, -47, 72, 677, -296, 307, 307,
    -12, 211, -211, 147, 857, -195, 307, 307,
    -130, 314, -253, 160, 1060, -89, 307, 307,
    -73, 151, -458, 10, 1115, -39, 307, 307,
    -61, -134, -671, -101, 922, 168, 307, 307,
    347, -384, -580, 52, 568, 429, 307, 307,
    904, 20, 574, 307, 307, 307, 307, 307,
    842, 990, 900, 938, 307, 307, 307, 307,
    -647, 643, 231, 829, 307, 307, 307, 307,
    16, 66, 428, 616, 307, 307, 307, 307,
    -554, 868, 217, 653, 307, 307, 307, 307,
    -969, 795, 998, 765, 307, 307, 307, 307,
    131, 113, 449, 449, 307, 307, 307, 307,
    9, -3, 786, 704, 307, 307, 307, 307,
};
// clang-format on

}  // namespace

std::string_view context_priors() {
  return kContexts;
}

std::span<const std::int16_t> weight_priors() {
  return kWeights;
}

}  // namespace mocapress
