// SPDX-License-Identifier: MIT
// Made by tests/bench/fit_priors.cpp.
#include "coefficient_priors.h"

#include <array>

namespace mocapress::decoder {
namespace {

// clang-format off
constexpr std::string_view kContexts =
    "2>@CEHLTHIIJLMPUJKLMOPRUKMMMOPSWOOPQQRTXPQRRSTVYTUSUUVX[WXXWZY[a4@ADFIMUJJJLMNQWKKLMNPRVLM"
    "MNOPSWNPPPQRTXQRRSTTVZUUVVVWY]Y^]Z[]^b6?ADFINWJJKKMNRWKLLMNORVLMNNOPSXPPPPQRTYSRSTTTVZVWWV"
    "WWY^_^Y`_]^c;@CEGJOZIIKKLNQWKLLMNORWNLMNOQSXQPPQQRTYTTTSSTVZZXVWWWY^g][_]]_eCCEGJMQ^IJKJMN"
    "QWMLLMNQSXNMNOPQTXRPQQQSUZVTSTTUW[[ZWWWWY^kY`^^^_fIEIKMQVdIKKMMPSXNMMMOQUYOMNPORU[SQRQSTV["
    "WRTUTUX[]ZXXXXZ_mbc_a__gPFLNPTYiHKLLOQUYNMLMORVZPNOPQSV[TQQQRTV]YUTTVVY^_TXXWXZ`kf]c]_`iWI"
    "ORTW]iIJLORSVXNLLNQUY^SPPRQTX_WSRSTUX_[TUUVVY`aVXZ[Z[ambYfbbbi*79;>AGSDFFGHJMTGIIJLMOTHJJK"
    "LNQVLMMOPQTXPPQRRTVZYUUVWVY^l bd^fag0:;=?BFNEDCCEEIQGIHIJKMQGGFGHILSKHHIJLNSLJOJLJNUCJJLGK"
    "NS        1;=?ADHMFEFEFGJQIIHIJKMOGHHHIILQLMJJKLNRMKLJKMPTO WJMNNU      JQ3=?ACFJPHGGGHIKQ"
    "JJJKKLNPHIHIIKMRKLKLKMNRMMJMMMPTPRMMNQQU   O  PS5?@CEHKQHIHIJKNRKKKLMNPRJKKLMMOSLMMMNOPTLN"
    "NNOOQTQSQPPQRVW  TOXSW7@BEGJMSIIJJKMOTLKLMNOQSKLLMNOQTNOOOPQRUPPPPQQSVPSQQRRSWOYUXYUUY9ACF"
    "ILOUIJKLMOQVKLLMOPSULMNNOQSVPPPQRRTWRRRSSTUXUVSUUUWYUSZWXWY]?CFHKNRYJJKLNPSXLLLMOQTWNMNOPR"
    "TXRQQQRSUYUSTUUUWZYXWWWXY[gXZZ[Z]`KGJKNQUbLLMNORUYNNNNPRUZQOPQQSV[TRSRSTW[XTUUVVX]_XXYXY[_"
    "le]``__dO     fc     O_gQ   XO^fW   UYWbc  TXVZ`a USWY[abc[XXZ`cr`]Y`hbk%&/3469;?BEHLORTWY"
    "[^`adfijlk    ('03479<>ADGKNQTVY[^`bcfhikje   -'22579<>ADGJNQTVY[^`bcfijoos   2+1259:<?BEG"
    "JMQTVX[^`adfhknr|   =.868:;?@CFHJNQTVY[^`adfilntu   G6899?<@BDFHKNQTWY[_`aehjlpv|   T<B;@@"
    "BCDEGILNRUWZ]_bbfiknsu|   g     KKJJKMOPSVY[^`b`gkkopus   EKJJIJTOS]AGHHGHIJLPDDGHHHJKMRIH"
    "IJIIKLNRNLNLLLMNORRVRNOOPPRTT   RTVSTV    QU_VWZ    QahWY^      vSYeDAEEEFVKOZ;@FCDDEFHMAF"
    "CEDEGGJPC@DDEEGHJPNEHDGGIHJOS_QIHJLKLO    PNSNOR     P]QRU     WeSUY      oWV`GBE>@DXILX B"
    "CABEEEHL>HDFFFIFHNFGEEEEIEHNI@EDDEJEGNR_=GEHMFHM    KJRIJN     UZNNQ     QbRQT      iQT]G "
    "H F@XFIV  ??:>ECGL   CA?JEFM   =EFKEFMT   DCMCEMOJ  9CODEL    HFRFFK     QXHIL      ]QNP  "
    "    gTPX      WHGV      HGJH     @O5@L    @@LBCM     HNFGL     KPCEL     GQEDK     OUGFK  "
    "    YNJM      bONV      VAGU        @N      Q  J      P=9L      M5<L     JNIDK      PBDJ  "
    "   @QAEJ      UKFJ      _QKS      U AT         >      M  J      P  I      O  K      MDFK  "
    "    N>GK      O DJ      QHBJ      [ NR      S  R                L  J      N  D      N  I  "
    "    O  J      M =J      M KK      N JJ      T JQSHHFFHFGGGHJLNQSVX[^`begjmpuu   VB?C?EBBCC"
    "DDFHKMPSVXZ^`cehlpq   [:HB;F@DDBBCEEFHKNQSVX[^adhmo   [    K>AJFFFIIFFFHKNQTVY[`dho   Y   "
    "    QIJJMPKIGFGILOQUW[`ei   X       U LGNSNNKIGGHLMPSW[ad   W       R   MTNNNLKIHMJMNRW]a "
    "  T       L M MSPNNNNMLRLOLOQST                                   HFHBGEDGFGGHIJKMNNNOOOOO"
    "ONOPP   LB@MCHEFGEFFGHIJLMNNNOOOONONP   N    L>KGFHFGHGHIJLMNOOOOPOPO   O       H=MLJKHHHH"
    "IKLMNOOOOOQ   O         HHLLJJIGHHIJLMNNOOO   M           JLKJJIIHHIJKLNNOO   L       O   "
    "JNMKKKJJIKJKJKLMM                                                                         "
    "          L       GI      HIJK    HHIJL   JIJJKMO KKKKLMN LLMMMNNOMMMMNNNNLMMNMNOONLMMNNOO"
    "M       HJ      GHJJ    HHHJK   IHHHILM IIIIIKM KKKKKKMNLLLMMMMNMMNLMMNNNMNMMNNOM       GI"
    "      GGJI    HIHKK   HHGIIKL HHHHHIL JIIIIIKNKJKKKKLNMLKLLLMNLKNLMMNOM       IK      IDJG"
    "    ICIJK   GEHIJKJ GGEIHIK IHHHIHJMIIIIIIJLJKJKKKKLLKLLLLMNL        N       @JJ    KHHLI "
    "  ILHFHJK ENDHHJJ HDCFHHJKFJIIIGHKLIIIIIIKLLHKKKKMM        O       JH       QJM      IKKH "
    "@  QAGJ L QCFHJKFGGHGFHJKIJJGGHJIJKKJIJLL                 I        KL       QLG      MK   "
    "   IIK    ODIJ   ?<CFJM BHLJIL                                JJJLNOOULLKLNOORPMIKMOOOOPML"
    "NOPRL IKLNOQJ JLMNOOL LLKMOOK HMLMNOL  LKLNOO  NLMNPM HLLLMNM HLLMNNOPNNOMOQOLLKNNMLMLRSQR"
    "RQPQPOPNOOMOQOMNLNNMNNMQRPPQPPQPOPNOOMOQNMMLNNMMNLQRPPRPPQPOOONPNOQOMMKNNLMNLQSQQRPPRPONPN"
    "ONPPONNLONMNNLPRQPRPPQPOLRNONPPPONMNNNONMPQPOPPPPPOLRNNNQPPPOPNNNOOOPOOOOPPOPOMQONMOQQOPQM"
    "POQOQOONMLNOOOOONOOPNNMMQPPPMNQRMPNLQONPNMQPQSNOSRRNMOQRMKKLPOPNMNPQ7LPQUY^gry8GKMQUZbo|8E"
    "GKMSYbm|<EGKNSWco|?HKKOTUep|@KKMPTVep|@HFLMSVen|I IILOYfq|7EFHHHERW GNPQSUY_m|7GHHKNMYc|AJ"
    "LKLOL`]cKQQTW[alr|CLOQSW]fs|                    <EKKMS^[l|                                "
    "                  9 AGHMS]fq8?EIOTYguz7LRU[dlq||                                        < "
    " AGKS[g{8 GEHNT]iv9BEINTXav|6GLPT[cq||                              ?   HOUaj|<  GGKS]l|7 "
    "@FIOV^gx8HHJMT]gv|5EHMQXa{{|                    E    NUahs@   MQWcn|<  GHNU]h|9 DGKQXbw|:H"
    "FLPW_oo|9EHLQWarz|                    B    TT[evB   KQYex|=  HKNU`i|> KGPT[nw|=GJKRZcnw|>H"
    "LNSZcmv|                    C    NU[grA   LPWcl|@  LPTZhn|? IKPU[hv|@GKNT^jst|APNUYaklmw  "
    "                  B    MV]axB   HPWcl|>  LNT_ev|@ GLR]hst|?HDKWhjklx                      "
    "        M    KYdp|J   KNXdo|F  JMVast|B IERYkkky                    TRKK#                 "
    "          H;2                             X^][ZYWVUUTSRPMJJM<             UZZYXWVUTTSRQONK"
    "JMPQ            vsqlidb`_ZXWWVUTROJD            eec`_][ZYXVVUTSSRPLIH           ZU_O'     "
    "      TRJH&                                                                               "
    "                                                                                          "
    "                                                                  H)              H<2     "
    "                                                                                          "
    "                                                                                          "
    "                                                    Y^][YXWVUUTRQPMKGNOPROPI        SNMMPP"
    "QL        YWNNMOPSO       ]]VNOOPNVI      c`]VNNKNI       kea^XMMKNPWM    spda_WLLJLN     "
    "{nkeb^VKKJKM    rzrkcb]VKJGN    yyyymed^VJHHH   xxxoojfb^UJHKM  wwwwwoohc`VJIKH vvvvvvvjfd"
    "aWIGE uuuuuuummigbWHF>vvvvvvvvviegaXMFVZZYXWVUTSRQPNNLHMOONOOG        RQPPOPMLR@      YWRQ"
    "POPLK?      _[VQPPNRMH      d`]VQPPNPJE     fd`]VPNOMPNK    jfe`]VPNOLNM?   jjffa]VONPMQKH"
    "  nnhhda[WONOLPMJ nnlkida]UOMMJN@ xxpkhgd_[VNKNMOLwwwjwhjea]VMMOMKuuuujjhff_ZWMHMIsssskhkk"
    "keb^VKJMrrrrrjrrggrb]ZPHvsqlidb`_ZXWWVUQ                                                  "
    "                                                                                          "
    "                                                                                          "
    "          eec`_][ZYXVVUTSQ                                                                "
    "                                                                                          "
    "                                                                                      SWQO"
    "#           SMLF0           WTH9;           _SE.            SPL/            MSF6          "
    "  tMG8            ]P/             WE;             nn1             n1              YY(     "
    "        uQD8                                                            G<5             L;"
    "8             K8              2               F1                                          "
    "                                                                                          "
    "                                                                          OWZZ[ZXWWVVUTRNJ"
    "RURSSSTSSQTTUUJ UVUSSQPPROOD    XXVVTSPONQQNN   Y[XVUTQOOOPNN?  Z`YXVTRQOOPPONM ]_]YXVSRRO"
    "OOQLN ^c_]YWURQQONMPK@`eb_[YWUSRRNMOOG`gd`_[YWURQQNKJF`iec`^[XVTRQQKIK`qgfb`^[XVTQPOIJa|ng"
    "fb^]YWVSPNKBc{pjfe`^[YWUSNJIr||uuhfc^[YWVSOKU[ZYXWVUUTSRQONLILNNMNQSO       QOMMOLI       "
    "  VSPOOMKI        ZWTPONMLKVJ     _[XTOOLNJE      c`[XSOOLMJ=     fd_ZXRONLLH@    gfd_ZWRO"
    "OKJG    jgce_ZVRNNMLH   mkgfd_ZVRNNLHG  {plgec^ZVRMMLMJ zrmigeb^ZVQMMIE xxoliddc^ZWQLLGOvv"
    "vnnfbe`^ZVOLIGvvvvmhdbbc]ZVSPIxxxme^[YYXWUURQN                                            "
    "                    ccccccccPQ      jjjjjjjj^NRE    kkkkkkkkcXMMG   lllllllllZWMNF  mmmmmm"
    "mm_ZUWMO> gooogoogdWRUVLSFpeehpceb`_VPUUMIpphappe`]_`VRVVMoooddood`]_bVSUPoooobgood^_caVRR"
    "uuuuumghheca`_[Rehd`_^[ZYYWVUTSQ_XU[UNO         WZP`Q           WTeQUaO         Z^__ROOO  "
    "      YccXXSPPR@      `^laWVRQOR@     d]^_[VVROPO     bg][[[UTSOOV@   pda[aZZUTQPQO   nffc"
    "___^XQPNN   ogodg_]_ZXNSLO  nnnncn^b[[VNSKJ nnnnnbf`e]ZSKRNOmmmmmmem[a[[ULSLrrrrrrrfrcca]Z"
    "UQ                ZM/             sMI8            JUJ6            UPR/            eSE0    "
    "        WVI:;           TJJG5           SWQO#           QRME4           XQD0            ZT"
    "D5            QO.             TQ0             jO8             ^T<8                        "
    "                                                    F1              2               8     "
    "          JF8             G<5             M&              O8                              "
    "                                                                                OWYY[ZXWVV"
    "VUTRNJRVTTRSTRRPSRSUJ UWWUUQQQQONJO   XXWWUTQPPPROOF  Z[XWVUSPPQPNK>  Z`ZXWUSRPPROQMK ^_]Y"
    "XWTSSPPQPNH _c_]YWVSRSPPPNMEaeb_[YWVSSSOOONJchda_[YWUSQROMMBfjfc`^[XWUSRRLLJhugfb`][XWTQPO"
    "IKt|mgfb]]YWVSPNKC{{ojfe`^[YWVSNJI|||tthfc^[XWVTOK                MSUUUUUTTUTRRPMIQTTTSSQS"
    "RTQTONTJTVTSSRQQOOROM?  VXVTSRQPONLJJ   YZXVSRRQOONOIJ  [^ZXUSSQPOONKH  ^a]YXUSRQPOPLMI `b"
    "a]ZWTRRQPNNNG cfc_]YWURQPNMJHJgkeb_[YWTRQOPNKCgmjea^[XVTQQOLMDlokgb`^ZXURQPMPJtqlkib_[ZWUQ"
    "PPLIzrrmjd`_[YXTPNMD{{sslhea^[YWUQONxxxme^[YYXWUURQN                                      "
    "                          ccccccccPQ      jjjjjjjj^NRE    kkkkkkkkcXMMG   lllllllllZWMNF  "
    "mmmmmmmm_ZUWMO> gooogoogdWRUVLSFpeehpceb`_VPUUMIpphappe`]_`VRVVMoooddood`]_bVSUPoooobgood^"
    "_caVRRuuuuumghheca`_[Rhfc`^[YXWWVTSRQPX_Y]Z[X^YYPTM   UVU^]VdZcSTVT   _[YXVYUffUMQ    [d]["
    "XVUXaZSMN  Peb_Z[XUUXVSTK@  fcfYY[VWTZTSQLOUcge`]YYWUTWTRQK gbcg][XWXXSWTNSKgrged][YWWVVXV"
    "RNqiiddf][WWUWTXSPfqibiib_[YYWVT[RepphechbZYXVTWRRhpppdhpgdZXZWVTRfnfnnfbebbWYVTSSphpppphc"
    "eh_ZXYUR QHGI                            H2                              OMMNNMMMMMMMMLKIJ"
    "E              OMMMMMMMMMLLLLKJFO                KQOOOPPOMMMMNNNMK             SNMOMMMMNNM"
    "MMNNNONKJ           ";

constexpr std::array<std::int16_t, 216> kWeights = {
    -793, 619, 1081, 307, 307, 307, 307, 307,
    207, 346, 271, -10, -104, 438, 307, 307,
    353, 78, 352, 79, -9, 680, 307, 307,
    503, -95, 223, -104, -247, 653, 307, 307,
    253, -157, 334, -171, -181, 547, 307, 307,
    351, -50, 477, -358, -210, 569, 307, 307,
    182, -28, 585, -234, -456, 477, 307, 307,
    248, -3, 657, 18, -462, 703, 307, 307,
    559, -56, 518, -62, -606, 529, 307, 307,
    84, 323, 100, -31, 293, 307, 307, 307,
    71, 293, 202, 92, 293, 307, 307, 307,
    -189, 329, 234, 376, 329, 307, 307, 307,
    -142, 298, 92, 291, 199, 307, 307, 307,
    96, 353, 132, 267, 236, 307, 307, 307,
    -80, 400, 125, 385, 221, 307, 307, 307,
    -15, 296, 88, 403, 300, 307, 307, 307,
    105, 53, 295, 429, 235, 307, 307, 307,
    264, 197, 139, 87, 307, 307, 307, 307,
    176, 393, -15, 382, 303, 177, 307, 307,
    -761, 902, 376, 734, 307, 307, 307, 307,
    15, 172, 540, 834, 307, 307, 307, 307,
    -278, 900, 191, 466, 307, 307, 307, 307,
    -996, 831, 1329, 432, 307, 307, 307, 307,
    409, -84, 395, 395, 307, 307, 307, 307,
    -12, -284, 1043, 807, 307, 307, 307, 307,
    388, 191, 162, 307, 307, 307, 307, 307,
    141, 179, 307, 307, 307, 307, 307, 307,
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
