// SPDX-License-Identifier: MIT
// Made by tests/bench/fit_priors.cpp.
#include "coefficient_priors.h"

#include <array>

namespace mocapress::decoder {
namespace {

// clang-format off
constexpr std::string_view kContexts =
    "-<=@CFJRDDFGHKNVIKJLMPQTGJHJLNQVJMLLNPRWLMLMOPSWNRPQRRTZOPUOQUX^0>?ADGJQIHIJLNOVJKJLMNPSIL"
    "KLMOQVLMNNOPSWNPPPPQTXPSSSRTUZ SXVXXY^2>@BEGLTJJJKKMOVKKLLMNPTLLLMNOQUNNPOQQSVRRPQRSTXTVSU"
    "UUVZ  _QYZZ`5>?BEHMUHIIJLMPVKKLKMOQVKMLMNORVNNPNPQSWRRRQRSUYTSVUUVW[TX[V_[[b;ACEHKOXIIJJKN"
    "QVLMLLNPRVLMNNNPSWQPPPQSTYSSRSSSVYRTWVVVX]ZUW[Y[]cDEGILPT_JJKNKOSVLLLMOPSYNMNOPRTZSQPRQRVZ"
    "URUTTUV[[[VWXXY_fc^_b`_eLFJKNRVeKJLLOOVZMLLLOQUZONNOPRUXSQQQSTW[XSTSTUW]^XWXVXZ_k ^c[_`hUI"
    "NQSV[hIKMNSQSTNKMNQSU[SONPQUW`VSPSSSX][VTVUVY^bVVZZY[_ne_cZbch(89<>AFQCDEFGIKUEEFHILMTCGFG"
    "IKNUHIJILNQWJKIKNORXX_NSPSU]r   `d^g/;<>ACFOFDGFFGJNFFHHJKMOEHGHHHMTHGKIILORHNKJLLOSNVKKQO"
    "RU      PS0<>@BEIPGDEGHJMSIIIJLLMRFIGHIKMTIJIJLLOUGJFKLLPVOOJRKNQU      SX3>?BDGJPHHHIIKMT"
    "JKIJLLNQHJJIJKNRIKJKLMOSLLIJLMOUERQPORRW     OVW5@ACEHKQIIJJJKNUKKJLLNORIKKLLMPTMLLLMNPUMN"
    "MMNOQUNQPORQRW    UQUY6ABDGJMSJIIKLMPUKLKMMOQTJLLNNOQUMNONPPRUOPOOPQRVNQPRQRTXRTUPUUX^8BCF"
    "HKOVJJKLMOQULLMMNPRULMMNOPSVOOPOQRSVRRRRRSUXTUTTTUVZSNVYXYY_@CEGJMQYJIJKMORXLMMMNPSWMMMNPQ"
    "SXQPQPRSUYTTTSTUVYXVWWVWX[dW_XY^]bNFIKNQVbKLLNOQTYMNNMPQUZQNPPPRVZTRQRSTV[XTTTUUW]_VWYXYZ_"
    "kb_^]__e       a       _      Zea    aS]_   aUX`_   V]^`g aU]]_cp  bb]bk3=CJ05<L48=B5:?D8:"
    "AF:=EI<ALX?DKQDGOWENVc+5?F-/8=14:@45;D78>F:;@H=>BK>@DO?AGP=GJW?DEF?@BO@AB=@ACEABDFBCEIDEGN"
    "EFIOFGKSFKPWAFHKA@D BCAGDCGGDEGHFFHKGHJPHIKOIJMRILQYGKKODH> GJI GHIKGIKJIILMJKMRKLNQLMOSMO"
    "RX  YUGN  I   IJ  JHL LMPNMNPVNOPROPQTPQTY    K   M   I   J@  MMM OPT_PQSTRSTVSTVZ        "
    "        K   LO  PS`hRUTYTUWXVWY]                    J   R dmPUb_VVX]WZ]`                  "
    "        iuU   UUUYZ_bh$#02368;?BEILNQSUVXZ[Zb_dlk     ''0457:=?BFIKNQRUWXY[X_db^i     )'13"
    "579<>AEHKNQSUWXZ]Z`cfloa    .)-2368:<@CGJMPSUWY[^^beijts    4/6668;=>ADFIMPSUWY[^_begjlsg "
    "  F7;3>:>?AADFIMPSVXZ]_`deijlrr   R99@CE>DBDEGJMPTVX[^`behknrrw   f  Q  JLLKHJLORUWZ[_abek"
    "kmsvt   NLJKMOSYNJJLMPTZLJJKMPSZLJJKMOT[KIKLMPT_RKLMORVaUJMNPRWcWKPPRUYeFIHIIKNUEEFGHJOVDD"
    "FFHJNUEDGFHJNWIDFGHKPYUGJJKMQ]VHKLMNR_XLNNOQUaBHFHGGJRDGDEEGJSEECCDFJREHFEFGJSKBHEFHKVWFJI"
    "JJMXVFLLLLOZXLNONOQ^=>AFFDGO<@AEBBFO><DABCFOHEHCEDFPM MIIEHSV=IJHIKUU LLKJLWXMMMONOZ   :D="
    "FN   ;:CEN    CACO  J@IFEOO IKKGGQV OOFHITU MPLKKVWJOPONNX      BM     @CN     @AN    @KAN"
    "J   FJCPU `K>LHRU RNMLKTU MMPMOV       M      ?M      JN      =M      JOS VT OJQR TJJOJST "
    "KQNOMT       M       M       M       M      NMP LO OJNO MO KKPR MKMMORMMMPRUYcLLNPQTWaMMNP"
    "RTX`NNNQRUX_OOOQSUX_POQRSVY_RQRTUWZaXRTVWY^fJIJKMPU_IIJLLOS[JJJKMOS[JJJKMOSZKJJLNPSZLLKMNP"
    "TZOMNOPRU[XOQQSUYbLHHIJLQ[IFGGHKNWIGGIIKOXKHIHJKOWKHHIJKOWLIIIJLPWOJJKLMQWXMNOPQT^QEFIIJNW"
    "L?DCIGKUMBFGGHKTJEGFFHKSLEEGGHKSNEHGFHLSOHHGIJLTWJKLMNPYTGIIJKLUN I;GJKSNJAEFGKSM;EABGJRNF"
    "EFGFJQNFFEFHIQPFFHHHJQVKJKKLMVTFJGIHKSQ   GDJSR  @=IHRO O >EJRL JDDGHPM@IEHEGOO;IFEFHOUALJ"
    "IIKTT =KHGJRQ     KQR    JKQM    @IQK    JFPK   MCFPN FDKHENS KKJIJRQ  J?<HOQ     MOQ     "
    "FOM     DNM     LOH     COK   HIGNQ KJJHIPMIIQKKJMKJJNKJJNLLLPMLMRMMMSPMNVXOOZh_ZhPFGPDEBJ"
    "EFDLBFEKFFEKHHHNIJJOPKKSXMMXfJZcWGERD=EJB@BJGBCJBEDKFEEMGGFMRJJPXLMVa U_YG;S   K   I> >J;D"
    "BJBBDNFDCLRHHOXKMT] N[Y  T   F   N   K   K  ?OLJEMREHOWMLS^  YX  S   O   G   N   J   OJ  M"
    "Q <OVPLRZ  VV  S       P   I   H   N   MN  NTKOQW  TR  P       G   K   L   M   MK  LRJMOS "
    " QHNLKKKTOR[DKKJJJKLMOFIIJJKLMORKIJKKLMMORROLONNNOPSSWTPPQQQRTa  TQQVTUW    `T`VWY     _lX"
    "Y]      yQXcCDFFEFUKOY7DDDEEFGIM@GEFGGIHJOFECFHGIIKONHCHIIJJKOQPONMKMLMPO   MPSOPR    HL[R"
    "SU     _hUUY      mYW`M?DDDDWGLW EFBBAGGGK FDEHEIGGMGH<EDFJGIN=H?BCEJGHMGM?KHGMHIM    PMRJ"
    "KO     NZNNQ     @cQRU      jRT]?  ?JGWFGV  J@<:FHGI   >BDIFGM   >LFKEGL    JFLDFL   ?JFNE"
    "FL    =LRFGL     LYLIN      ^MMQ      fGPX      WGFU      F<?I     ?O9AK    L;MGIL    OIOH"
    "EL    ?MOFFL     IRFFK      UKGL      YQLN      c LV      U JT                O  J      P="
    ":K      LD9K     _PNHJ     @OHEK      QFCK      VMKL      ^ RT      T  S                M "
    " I      Q  J      P  K     @M;;I      MLHJ      ONJJ      P=GK      Z MR      Q  Q        "
    "        L  J      L  F      L  H      O  J      N  J      M MI      M @I      S @PRKIIIIHI"
    "IJJLMOQTVXZ]_`cfimpw{   TACABEACBDEFGIKNPSUWZ]_begkpo   YF?=BBBCCABCEFGIKNQSVXZ^adhml   [ "
    "     =E@FEHIFGGIKNQTVY[`dhm   Y         GKNPLJHHIJLORUX[`eh   X          FQRNMLJIIILNQSWZa"
    "d   U           OUONMMKJIMKMOSV[`   R           JQLPLMNMKPKNLOQSS                         "
    "          GADDGIGGGGHIJKKLNNNNONOOOPMP    L>M=CFHHGFGGHHIJLMMNNOOOOOORT   N      IJ@FHGGHI"
    "IKLMNNONOPOQ    M         SLJHHHIIJKLMNNOOOOI   M          WQLHKHHIIJKLMNOONO   N         "
    "  PKKLKHIHIIJKMNNOR   N           MMIIJJJKIKJKKLLMM           LKLLMMMMKKKLLMMMKKKLMMMNJKKL"
    "MMMMKKKKLLMMLJKKKLLMKJKKKKLL                                                              "
    "                  K       HK      HIJL    IJJKL   JJKKKMM KLLLLMN LLMMMNNNKMNMNNONMLMMMNOO"
    "KIMLMNNOL       HJ      HGJJ    IHHJK   HIIIJKN IIIJJKM KKKKKLMNLLLLLMMNMMMMMMNOKLNMMNNOM "
    "      HJ      FCKI    HIJJK   HHGIIKL HIHIIJL JJJJJJKNMJKKKKLNNMLLKLMNNLJNLNNOM       IP  "
    "    I JF    CHGKL   FJCHKKM FIJIIIK JGIHHIJMFIIJIJKMLKJIKKLMJNMILLMNM                 LO  "
    "  I  KI   G?@KKKL  JI@JIJ HFGGFGJKIILHHGIKHFIHIJILKFMKMKKMM                 K        OI   "
    "    HJJ     >@M    HQKKI   =FIFK> MMHIIK? HKKIKLL                 F        KM        ML   "
    "    H       JK    G HJ     DGK   LFKIL                                HKJLNOO KNLLNOO TGJK"
    "MOO V OMNOP L JKLNOGL MLMNO K  LKMNNL >LLNNPM  KLMNOI  QMMNOJ  LLLMMO  LMMNLOQNOOLORNMNLON"
    "MLLLQSQSSQORPOPNNONPPPMNMMNMNNMQRPOQPOQPOQNOPMPQOMNLONMMNLPRPPRPOQPOPNOPMOQNKMJMNLMMKRTQRS"
    "QPSPNOONPMPPOLMJNNKLMKQSQRSQQRPOMQNOOPPOONLMMMNMLOQQPQQQQPOKROMNQPPONOOMNNNNPPPPOPRPQOMQQN"
    "OOQPOPPLPOMOQPNNPMOROOOONOPPNNNLSPPPKNPQMONKQONPNMQQQSNNSSROMOPSMKKKPPPNMNPR4MSVZdsrmk3HNP"
    "SVZ_it5EIMPTX_gp7EGINTZck|<FJLOSZbkwAKJMPTVly|AOKJNRTcjyF OQPTXdq|5FFJHHENa AKPTUTY^dx5IIJ"
    "MPNZcp@HLLNRMZ` JOSXW^bkt|CLPQSW[en{                    9FDMPR_adx                        "
    "                                    + <DSYff`_5MSX[gsqmk                                  "
    "                          3:?CGLSYhp3HOTW_eiip                                            "
    "      3 BDELOVal6HJMQS_epr4EJNUZfvtv                                        >  ;JPVZcz5 AD"
    "JQVary1>CDMVfnou5EHLRXavuy                              B   NPU`i{9  JIMUZdp2 ?EMUamnw6GHM"
    "NT_ppv;GKMSZftt{                    E    PThhrB   NRXkr|@  LPUallx= GINPVdqyALKMRZbqr{DJNU"
    "T^klkv                    =    NTX[jC   KPU`exB  JHNXdpz; KIPX^hq|BOLMS^jklv              "
    "                F    OXakxG   PQYanyF  RPZ`qr|D OOTfkjlw                    UUOI'         "
    "                  KF.                             X][ZYXWUTSRPNKJJJ               UYYXWVUT"
    "SRQPONNSRNO             wwolhdb_^ZWUUSOKJ@              feca^[YYXVUTRSPNKH              wV"
    "YQ-           TUOG*                                                                       "
    "                                                                                          "
    "                                                                          MF7             "
    "JF/                                                                                       "
    "                                                                                          "
    "                                                            X][ZXWVUTSRQNMLIHNQRPUN       "
    "  TQMLSL          ZXPMMOO         _^WNONMO        bb]UNOLOH       he_^VPLIO       tlab_UOJ"
    "HO      tttc``VLIG      ssskh``VJKD     rrrrgae_UKHF    qqqqqqab`VJG?   pppppphcedWHJ?  oo"
    "ooooogdddTGD  kkkkkkkkk`c]XF? ddddddddddZcZS> VYYXWVUTSRQPOOPRIOOOPTMJ        QQOPLMG     "
    "    YWSPPOONM       _]WROOORJ       dc]WROPKOG      ki`]XQMQPQK     gkf`]VQLONQG    jhmf`]"
    "VOLONN    ttlgia^WNKPRTH  sssshg_[VOKPQL  qqqqfi`_]TNJRQ  ooooogogc[VLHO  llllllladlZWMJO "
    "hhhhhhhhh_g_TH                  wwolhdb_^ZWUUSOJ                                          "
    "                                                                                          "
    "                                                                                          "
    "                  feca^[YYXVUTRSPM                                                        "
    "                                                                                          "
    "                                                                                          "
    "    PTSQ*           RPMI4           [XNH0           xYID<           f^R-            R^RA< "
    "          [Z[><           UOP7            VQI`?           XM<             pK5             "
    "XQA?            oZ1                                                             HC5       "
    "      OG2             UL7             fS<             J5                                  "
    "                                                                                          "
    "                                                                                  QWYXYZ[Z"
    "WTURNK< RVUUSSTOHT      UXVTTRPQROI     XXXVUSPPOOMO    YZXWVVTRNNSNG   Z_YXWVTSPMPSO?  [`"
    "]WXVTRRPKPF   [`_ZXXVSSSOLKJ  ]d`^XXWTSRSNJJ  ^gb^^XXVSRPOOF  _iaa[ZYWUTQONJ@ dkfba[ZWWWRN"
    "LPF uufgbaZZUVVQMG  qqqff^e[[XVRLLH pppphh][YYWVTQQJUZYYWVUTSRQPNLNPIMMQPPQRT       PNNJKQ"
    "          USRNNOML        XVSQPNMNM       _ZVTQPLMPL      b_ZURPOMKT?     ha][VRQMOMOO    "
    "jj`]ZVRPONKVJ   kng_[YTROOKK    umje_]XVROPPMVJ ssksh^[YUOQJNJ  qqqiif^YZUORJL Onnnnnf_]ZU"
    "RRPNORllllllldZYUSNO@ hhhhhhhhh__ZZWQRqqqqd_[YVURQQMH                                     "
    "                                            bbbbbbbbbRQ     dddddddddZMT    fffffffff^YF  "
    "  ggggggggg_WYPP@ iiiiiiiiiXRTdNQ kkckkbkkb_WQWTKPkkk_jjb_^^]XQUVHhhhh_ggg[Z^^TRTNiiiia`hh"
    "```__UJ@lllllldadd]^YWSJgfd`_]ZXXWVSRTRMaWVT            ``Q             WQ              d["
    "ZZNT          f]e]USTQ        _^ffYVSUO       [_g_gXSTOJ      aiaaWWTXQTM     ii```YVUWMO "
    "    ai`hhhXXWPOT    gg__g_g^^^MRO   iiiiii``XUTLO   hhh__ggg_VTPG   cccccYbbbbbXTM  hhhhhh"
    "hhhhhhhYPK                cSKE?           bbb-            Oq].            rbb-            "
    "vWLD<           {[QH0           UOOL4           PTSQ*           PQJ4            TQ=?      "
    "      qq.             aYC<            pXGS<           XWXC<           XO-                 "
    "                                                            J5                            "
    "  ?               JM9             HC5             PE4             WL7             fS<     "
    "                                                                                        QX"
    "XXYZZYWTURNK< RWVVRRTOLPM     UYWUURPRPOK     WXXWVTQQPOOL    ZZXXWWTROOQMF   Z_YXWVUTQNPP"
    "O>  ]`]WXVTSRQMRF   _`_ZXYVTSSOMLG  cc`^XXXSTRSNKI  dfb^^XWWSSQOOF  fjba[YYWUTQONK@ nngba["
    "ZWWWROLPF ttigbbYZUVWQMG  qqqep^e[]WVRLMH oooogg`^XYVZTRQJ                NTUUUUTTTTROOKJ "
    "QTTTSPQPPRQL    SVTTTRPOPMPQ    VWVUSSQPQPLN    X[WVURSPONQMM   Z]ZWVTRROPJSN  O^_]YVTSRPO"
    "MHO   bb^[YVTRQONL<   de`_ZYVTSPOMKG  lgd`_YXUSRQOMI  jlfa^]ZXUQPSLK@ mumdb^ZWYURPPHO sskh"
    "da^ZXVUROQMNhpphhb^[XWXSPJQRqqhpee_^YWUWVSRSqqqqd_[YVURQQMH                               "
    "                                                  bbbbbbbbbRQ     dddddddddZMT    ffffffff"
    "f^YF    ggggggggg_WYPP@ iiiiiiiiiXRTdNQ kkckkbkkb_WQWTKPkkk_jjb_^^]XQUVHhhhh_ggg[Z^^TRTNii"
    "iia`hh```__UJ@lllllldadd]^YWSJide`^ZXXUSSSNQTNaaaaWVT         WQWV_T          [[WUbXW```H "
    "    [[XY][WZccYI    bbXaZXVUWcQWH   ll`ZXXWVWVZQRO  emm[[YWU[R]XRXO dlld[ZYWXYR[SUWJdlll_^"
    "XZSYUScZI lllll__ZZTSTSSaFbjajjjaY`UVScOVNiaiaiiiiX[ZSUYOQgggg_gggZWXWNT RbbbbbbbbbTVT    "
    "ccccccYXbbbXaRJ  PJLG                            GD                              NMNNMNNML"
    "MMLIEJ                 OMMMMMLMLLLLKLQFJ                  QSPMNRONMMNOKJ               RPN"
    "OPNNLNNMJOLGH@              ";

constexpr std::array<std::int16_t, 200> kWeights = {
    -541, 682, 1029, 307, 307, 307, 307, 307,
    -304, 1190, 20, 718, 78, 307, 307, 307,
    224, 689, -74, 459, -168, 307, 307, 307,
    231, 281, 179, 627, -136, 307, 307, 307,
    504, 332, 115, 312, -101, 307, 307, 307,
    588, 8, 326, 255, -189, 307, 307, 307,
    345, 131, 44, 511, -156, 307, 307, 307,
    371, 174, -62, 724, -63, 307, 307, 307,
    -181, 154, 331, 405, 53, 307, 307, 307,
    408, 375, 88, 138, 550, -399, 307, 307,
    345, 329, 77, -10, 679, -322, 307, 307,
    341, 277, -133, 85, 657, -266, 307, 307,
    0, 185, -169, 154, 845, -183, 307, 307,
    -108, 349, -283, 150, 1049, -107, 307, 307,
    -84, 113, -463, 30, 1120, -19, 307, 307,
    -103, -156, -654, -82, 921, 194, 307, 307,
    326, -361, -568, 39, 548, 421, 307, 307,
    817, -15, 567, 307, 307, 307, 307, 307,
    810, 1070, 780, 1046, 307, 307, 307, 307,
    -647, 643, 231, 829, 307, 307, 307, 307,
    16, 66, 428, 616, 307, 307, 307, 307,
    -593, 863, 245, 677, 307, 307, 307, 307,
    -942, 778, 1002, 773, 307, 307, 307, 307,
    127, 108, 452, 452, 307, 307, 307, 307,
    20, 7, 769, 704, 307, 307, 307, 307,
};
// clang-format on

}  // namespace

std::string_view context_priors() {
  return kContexts;
}

std::span<const std::int16_t> weight_priors() {
  return kWeights;
}

}  // namespace mocapress::decoder
